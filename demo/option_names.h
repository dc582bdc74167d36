/* The words that options allow, by their place in the list; NULL behind its end. */
#ifndef OPTION_NAMES_H
#define OPTION_NAMES_H

const char *option_flip_name(int index);
const char *option_preview_name(int index);
const char *option_map_name(int index);
const char *option_view_format_name(int index);
const char *option_mask_name(int index);
const char *option_depth_name(int index);
const char *option_submission_name(int index);
const char *option_picture_kind_name(int index);
const char *option_picture_place_name(int index);

#endif
