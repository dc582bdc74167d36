/* The pictures on the six faces of the cube room, painted by the CPU. */
#ifndef SCENE_CUBE_PICTURE_H
#define SCENE_CUBE_PICTURE_H

enum { CUBE_PICTURE_SIZE_PX = 1024, CUBE_FACES = 6 };

/*
 * A face of the room and how someone inside who looks at it sees its picture upright. Whoever looks
 * up or down faces the front wall before.
 */
struct cube_face {
    const char *name;
    const char *axis;
    const char *beyond[4]; /* the faces that lie above, below, left and right of this one */
    float outward[3];
    float right[3];
    float up[3];
    unsigned char ground[3]; /* sRGB */
    unsigned char shade[3];
    unsigned char plate[3];
    unsigned char ink[3];
};

extern const struct cube_face cube_faces[CUBE_FACES];

/* rgba: 4 CUBE_PICTURE_SIZE_PX^2 bytes, out; rows from the bottom up. */
void cube_picture_paint(int face, unsigned char *rgba);

#endif
