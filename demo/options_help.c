/* What cupola-demo --help says. */
#include <stdio.h>

#include <cupola/rig.h>

#include "options.h"

static const char usage_text[] =
    "Usage: cupola-demo [OPTIONS] [MODEL]\n"
    "Draws a scene on a dome. MODEL is whatever assimp reads (OBJ, PLY, glTF, 3DS ...); without\n"
    "one the room --scene cube is drawn. With a display it opens a window (H or F1 there names\n"
    "the keys); with --output or --headless, or without a display, it writes a picture and ends:\n"
    "--output FILE, else dome.png (dome.pfm for a scene of numbers) in the current directory.\n";

static const char scene_text[] =
    "\nScene\n"
    "  --scene NAME           cube | forest | directions | screen; the colours of directions and\n"
    "                         screen are numbers: the ray, or the point of the screen that it "
    "meets\n"
    "  --shading NAME         flat | lambert | heavy: material colour as it is, and a MODEL "
    "without\n"
    "                         sky and floor; one lamp or the sun; or sixteen lamps, physically\n"
    "                         based, on bumps; default lambert\n"
    "  --flat                 the same as --shading flat\n"
    "  --triangles N          of the forest, 1000 to 50000000, default 1000000\n"
    "  --seed N               of the forest, 0 to 1000000, default 0\n"
    "  --camera X,Y,Z         where the dome's centre stands in the world; default 0,0,0, for a\n"
    "                         MODEL a sensible place, which is printed\n"
    "  --look X,Y,Z           the point of the world that the camera looks at; default along -Z\n"
    "  --up X,Y,Z             the direction that is up; default 0,1,0\n";

static const char picture_text[] =
    "\nExisting pictures instead of a scene\n"
    "  --show IMAGE           PNG, JPEG or PFM (what else stb_image reads, too); a name with %04d\n"
    "                         or the like is a sequence from 0 or 1; a cube needs %s in the name,\n"
    "                         for posx (right), negx, posy (up), negy, posz (ahead) and negz\n"
    "  --as KIND              domemaster | equirectangular (twice as wide as high) | cube\n"
    "  --frame-rate N         of a sequence in a window, pictures a second, default 30; without a\n"
    "                         window each frame is the next picture: see --output\n"
    "  --picture-fov DEG      full opening of a domemaster, default 180\n"
    "  --picture-aim YAW,PITCH,ROLL\n"
    "                         turns the picture, degrees: a domemaster from the dome's axis, the\n"
    "                         others from straight ahead\n"
    "  --picture-place WHERE  screen | infinity: painted on the screen, or far away; default: a\n"
    "                         domemaster on the screen, the others at infinity\n";

static const char mark_text[] =
    "\nOver the dome's image (32 of them at most)\n"
    "  --label TEXT@YAW,PITCH[,HEIGHT]\n"
    "                         text of 1 to 100 characters, upright as the viewer sees it; "
    "degrees,\n"
    "                         of the camera: to the left and up, -360 to 360; height of a line\n"
    "                         above 0 and up to 90, default 4\n"
    "  --cursor YAW,PITCH     the ring that a mouse has in a window; likewise\n";

static const char rig_text[] =
    "\nRig (options override the rig file, which overrides the preset)\n"
    "  --rig FILE             a rig file\n"
    "  --save-rig FILE        writes the resulting rig, keeping what was there as FILE.bak, and\n"
    "                         goes on\n"
    "  --lens NAME            angular | hemispheric | equisolid | stereographic | polynomial | "
    "table\n"
    "  --fov DEG              full opening angle\n"
    "  --lens-k K1,K3,K5,K7   of a polynomial lens, angles in radians, 1 to 4 numbers;\n"
    "                         implies --lens polynomial\n"
    "  --lens-table FILE.csv  of a table lens: lines angle_deg,radius; implies --lens table\n"
    "  --flip x|y|xy          mirrors the picture\n"
    "  --size WxH             of the picture; without --circle, the circle scales along\n"
    "  --circle CX,CY,R       image circle in pixels, origin bottom left\n"
    "  --tilt DEG             of the dome's axis above the line of sight, -180 to 180\n"
    "  --cap DEG              half-angle of the screen round the dome's axis, up to 180\n"
    "  --viewer X,Y,Z         the viewer's eye, metres, origin at the dome's centre, axis -Z\n"
    "  --projector X,Y,Z      the lens of the projector, likewise\n"
    "  --projector-aim YAW,PITCH,ROLL\n"
    "                         degrees\n"
    "  --radius M             of the screen, metres, up to 1000\n";

static const char plan_text[] =
    "\nViews and tables\n"
    "  --layout NAME          auto | asymmetric | rotated\n"
    "  --views N|auto         1 to 8\n"
    "  --goal NAME            fill | vertices | auto: what the plan is to save; auto: the views "
    "of\n"
    "                         the scene are timed first\n"
    "  --density D            texels per pixel along a line: 1 is no loss, 2 four times the "
    "texels\n"
    "  --view-size PX         longer side of each view without its guard band, instead of "
    "--density;\n"
    "                         1 to 16382, as far as all views fit into a texture\n"
    "  --guard PX             guard band round each view, default 2\n"
    "  --head-radius M        the views suffice for a viewer who moves, up to M metres\n"
    "  --eye-circle M         moves the viewer round the dome's axis, in a circle of M metres;\n"
    "                         --head-radius is M if it isn't given: see --output\n"
    "  --osc [HOST:]PORT      the eye is where messages /viewer x y z say, metres, as --viewer, "
    "by\n"
    "                         OSC over UDP; heard from this machine alone unless HOST is another\n"
    "                         address of its own, or 0.0.0.0 for all; port 0: any that is free;\n"
    "                         --head-radius is 1/5 of the screen's if it isn't given\n"
    "  --viewer-lookahead MS  predicts the eye of --osc so far ahead, 0 to 500, default 20\n"
    "  --view-format NAME     rgba8 | srgb8 | rgba16f | rgba32f; default srgb8, for files and "
    "scenes\n"
    "                         of numbers rgba32f\n"
    "  --msaa N               samples per texel, 1 to 64, as many as the GL has; default 1\n"
    "  --depth WAY            forward | reversed: from 1 near to 0 at infinity; default forward\n"
    "  --mask WAY             auto | none | depth | stencil: where what no pixel samples is kept "
    "from\n"
    "                         being shaded; auto is depth\n"
    "  --submission WAY       auto | once | loop: all views in one pass, or one by one; auto: the\n"
    "                         former where a vertex shader of a GPU can choose the view; with\n"
    "                         --goal auto one by one\n"
    "  --table STAGE          none | angles | sines | points | coordinates | tiles | auto:\n"
    "                         the fastest of them here; default tiles\n"
    "\nAntialiasing\n"
    "  --aa METHOD            none: the nearest texel | texture: the mean of those round the hit "
    "|\n"
    "                         cone: rays in a cone of the pixel's solid angle | adaptive: the "
    "same,\n"
    "                         as many as the pixel covers texels | footprint: rays along the long\n"
    "                         axis of what it covers; default texture\n"
    "  --samples N            rays of a cone, at most of adaptive and footprint, 1 to 64; texels\n"
    "                         of texture, 4 or 9; default 4\n"
    "  --pattern NAME         regular | rotated-grid | blue-noise: of cone and adaptive\n"
    "  --turned N             their pattern is turned from pixel to pixel, by seed N\n"
    "  --dither               noise of the last of 8 bits, so that slopes of light show no steps\n";

static const char show_text[] =
    "\nWhat is shown (one of them; default: the dome's image)\n"
    "  --perspective          one plain perspective view; its fov, up to 170 degrees, spans the\n"
    "                         diameter of the image circle, as the lens's does\n"
    "  --views-only           the views side by side instead of the warp\n"
    "  --preview eye|outside  the simulated theatre, all outputs in it, seen from the viewer's "
    "eye\n"
    "                         (60 degrees from bottom to top) or from outside\n"
    "  --map density          the solid angle that each pixel covers, as colours with a scale, or\n"
    "                         as numbers, sr; needs --output FILE.png or FILE.pfm, and no GL\n"
    "  --show-output N        the rig's output that is shown and that options like --lens change;\n"
    "                         default 0, the first\n"
    "\nWhere\n"
    "  --headless             no window\n"
    "  --frames N             draws N frames and ends\n"
    "  --reference N          the mean of N frames, whose samples lie beside the middles of "
    "pixels\n"
    "                         and of the views' texels: 64 are good, 256 hardly differ from more,\n"
    "                         odd numbers shift the picture a little; views are sampled with --aa\n"
    "                         none unless --aa says otherwise; for each picture of a sequence. No\n"
    "                         window. FILE.part beside the picture holds what is done: the same\n"
    "                         command goes on after SIGINT, SIGTERM or whatever else ended it\n"
    "  --output FILE          FILE.png or FILE.pfm (floats); no window; of a sequence with %05d\n"
    "                         or the like in the name: a file for each picture, of the same\n"
    "                         number; --frames then says how many. With --eye-circle likewise:\n"
    "                         one turn, numbered from 0, in 120 files without --frames\n"
    "  --stats FILE.json|-    measured times as JSON, to stdout for -; 10 frames without "
    "--frames;\n"
    "                         one frame more is drawn first and not counted; also the plan, why\n"
    "                         it is as it is, and the mask, submission and table stage used; see\n"
    "                         cupola-demo(1)\n"
    "  --report FILE.json|-   how well the plan's views and the rig's outputs fit: texels per\n"
    "                         pixel, pixels per degree, texels never sampled, an advice; alone it\n"
    "                         draws nothing and needs no GL; see cupola-demo(1)\n"
    "  --monitor N            the window is on monitor N, 0 the first\n"
    "  --fullscreen           and fills it\n"
    "  --swap-interval N      of the window, 0 to 60; default 1\n"
    "  -h, --help, --version\n"
    "\nExit status: 0; 1 for failures; 2 for wrong options; 3 for a --reference that was\n"
    "interrupted.\n";

void options_print_help(void)
{
    char presets[300];

    value_name_list(cupola_rig_preset_name, presets, sizeof presets);
    fputs(usage_text, stdout);
    fputs(scene_text, stdout);
    fputs(picture_text, stdout);
    fputs(mark_text, stdout);
    fputs(rig_text, stdout);
    printf("  --preset NAME          %s;\n"
           "                         default: a full circle of 1024x1024, angular 180, tilt 0\n",
           presets);
    fputs(plan_text, stdout);
    fputs(show_text, stdout);
}
