/* What cupola-calib capture --help says. */
#include <stdio.h>

#include "capture/options.h"

static const char usage_text[] =
    "Usage: cupola-calib capture patterns --rig RIG.cfg --folder DIR\n"
    "       cupola-calib capture show --patterns DIR [--device /dev/videoN --folder PHOTOS]\n"
    "       cupola-calib capture decode --patterns DIR --folder PHOTOS --rig RIG.cfg\n"
    "                    --camera LENS --output MARKS.csv [OPTIONS]\n"
    "       cupola-calib capture simulate --rig TRUE.cfg --patterns DIR --camera LENS\n"
    "                    --folder PHOTOS [OPTIONS]\n"
    "Marks by structured light: the projector shows a series of patterns, a camera photographs\n"
    "each, and from the photographs follows which of its pixels lights which place of the screen.\n"
    "Metres, degrees and pixels. COORDINATES OF PHOTOGRAPHS COUNT FROM THE BOTTOM LEFT, as all\n"
    "of Cupola's: y = height - (what a picture viewer says).\n";

static const char common_text[] =
    "\nAll of them\n"
    "  --rig FILE             patterns: of what size the projector's image is; decode: also the\n"
    "                         screen, the viewer and the tilt; simulate: what really stands there\n"
    "  --projector N          which of the rig's, from 0; default 0\n"
    "  --folder DIR           where pictures are written; decode: the photographs, in the order\n"
    "                         of their names\n"
    "  --patterns DIR         the folder that 'capture patterns' wrote; decode: default --folder\n"
    "  --help                 this text\n";

static const char patterns_text[] =
    "\npatterns\n"
    "  --period PX            of the sines, even, 8 to 1024; default 16, for large images a 64th\n"
    "                         of the longer side: in photographs it should be 6 pixels or more\n"
    "  --steps N              of each sine's phase, 4 to 16; default 4\n";

static const char show_text[] =
    "\nshow (space, enter: next; backspace: the one before; escape: end)\n"
    "  --monitor N            which monitor, from 0; its image must be of the patterns' size\n"
    "  --window               in a window of that size instead of all of the monitor\n"
    "  --every S              goes on by itself after S seconds\n"
    "  --device FILE          photographs each picture with this V4L2 camera, into --folder\n"
    "  --photo-size WxH       asked of the camera; default: its own\n"
    "  --shots N              photographs of each picture, averaged, 1 to 1000; default 1\n"
    "  --settle N             frames of the camera that are passed over after the picture has\n"
    "                         changed, 0 to 1000; default 5\n";

static const char decode_text[] =
    "\ndecode [PHOTO ...]        (PNG, JPEG or PFM by name and in order, instead of --folder)\n"
    "  --output MARKS.csv     the marks: points of the screen and the pixels that light them\n"
    "  --marks N              about how many, 12 to 5000; default 300\n"
    "  --linear               PNG and JPEG hold light as it is; default: sRGB. PFM always is so\n"
    "  --contrast C           between all light and none at least, 0 to 1; default 0.02\n";

static const char camera_text[] =
    "\nThe camera (decode and simulate)\n"
    "  --camera LENS          rectilinear:FOV (an ordinary one, FOV across the picture's width),\n"
    "                         equirectangular (a panorama), angular:FOV, hemispheric:FOV,\n"
    "                         equisolid:FOV or stereographic:FOV (a fisheye)\n"
    "  --camera-circle X,Y,RADIUS\n"
    "                         the fisheye's image circle; default: the largest, in the middle\n"
    "  --camera-position X,Y,Z\n"
    "                         where it stands, dome frame; default: the viewer's eye\n"
    "  --camera-aim YAW,PITCH,ROLL\n"
    "                         from the viewer's straight ahead: to the left, up, "
    "counter-clockwise;\n"
    "                         default 0,0,0\n"
    "  --references FILE      decode: marks whose x_px, y_px are places of the PHOTOGRAPH; with\n"
    "                         them the camera's pose is solved for, from --camera-position and\n"
    "                         --camera-aim as a start. simulate: such a file is written\n"
    "  --camera-free LIST     decode: what is solved for: pose (position and aim), position, aim,\n"
    "                         fov, center; default with --references: pose\n"
    "  --solved RIG.cfg       decode: the rig with the projector as found together with the "
    "camera\n";

static const char simulate_text[] =
    "\nsimulate\n"
    "  --photo-size WxH       default 1280x960\n"
    "  --exposure E           what full light becomes in the picture's middle; default 0.8\n"
    "  --ambient A            light on the unlit screen, of the projector's, 0 to 10; default 0\n"
    "  --vignetting A         what is missing in the corners, 0 to 0.95; default 0\n"
    "  --blur PX              standard deviation, 0 to 16; default 0\n"
    "  --noise SD             of light at full white, 0 to 1; default 0\n"
    "  --seed N               of the noise, 0 to 1000000; default 0\n"
    "  --format NAME          png | png16 | pfm; default png\n";

void capture_help(void)
{
    fputs(usage_text, stdout);
    fputs(common_text, stdout);
    fputs(patterns_text, stdout);
    fputs(show_text, stdout);
    fputs(decode_text, stdout);
    fputs(camera_text, stdout);
    fputs(simulate_text, stdout);
}
