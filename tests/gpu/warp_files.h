/* What the program warp_files writes. */
#ifndef WARP_FILES_H
#define WARP_FILES_H

enum { WARP_COUNT = 6, WARP_WIDTH = 160, WARP_HEIGHT = 120 };

#endif
