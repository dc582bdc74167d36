/*
 * Cameras: from a place of a photograph to the ray that it sees, and back. Places are continuous
 * image coordinates, origin bottom left.
 */
#ifndef CAMERA_H
#define CAMERA_H

#include <stdbool.h>

#include <cupola/rig.h>

enum camera_kind {
    CAMERA_FISHEYE,         /* any of Cupola's lenses, with an image circle */
    CAMERA_RECTILINEAR,     /* an ordinary camera: straight lines stay straight */
    CAMERA_EQUIRECTANGULAR, /* a panorama: 360 degrees of yaw across, 180 of pitch upwards */
};

struct camera {
    enum camera_kind kind;
    int width;
    int height;
    double fov_rad;               /* of an ordinary camera, across the width */
    double center_px[2];          /* of an ordinary camera: what its axis meets */
    struct cupola_output fisheye; /* of a fisheye; complete, at the origin, not turned */
    double position_m[3];         /* dome frame */
    double rotation[9];           /* columns: its right, up and backward axes, dome frame */
};

/*
 * "rectilinear:FOV", "equirectangular" or "MODEL[:FOV]" of a lens, degrees, as `kind`, `fov_rad`
 * and the fisheye's lens. False with one line in `message`, MESSAGE_SIZE bytes, that begins with
 * `option`.
 */
bool camera_parse(const char *option, const char *text, struct camera *camera, char *message);

/*
 * Fits it to photographs: an axis through their middle, and for a fisheye the circle, or, where it
 * is NULL, the largest that fits. False as above where that is impossible.
 */
bool camera_fit(struct camera *camera, int width, int height, const struct cupola_circle *circle,
                char *message);

/* Aims it, from the way that the viewer of a dome with this tilt looks straight ahead; and back. */
void camera_aim(struct camera *camera, double tilt_rad, const struct cupola_aim *aim);
void camera_aim_of(const struct camera *camera, double tilt_rad, struct cupola_aim *aim);

/* The ray that a place sees, dome frame, unit length. False: the place lies beyond the lens. */
bool camera_ray(const struct camera *camera, const double place_px[2], double ray[3]);

/* The place that shows a point, dome frame. False: it lies behind, or beyond the picture. */
bool camera_place(const struct camera *camera, const double point_m[3], double place_px[2]);

/*
 * Where a ray from a position meets the screen's sphere, the far side of it: the origin's. Where it
 * misses the sphere: false, and the point of the ray that comes closest.
 */
bool camera_meets_sphere(const double position_m[3], const double ray[3], double radius_m,
                         double point_m[3]);

/* How far apart two rays of neighbouring pixels are in the middle of the picture. */
double camera_pixel_rad(const struct camera *camera);

#endif
