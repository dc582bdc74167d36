/* Measured times, and the JSON object that --stats writes. */
#ifndef STATS_H
#define STATS_H

#include "show.h"
#include "viewer_osc.h"

struct stats;

/* `path`: a file, or "-" for stdout. NULL if out of memory. */
struct stats *stats_create(const char *path);

/* Drops the file unless it was kept. NULL is allowed. */
void stats_destroy(struct stats *stats);

/*
 * Frames to be counted when the user wished for `frames` (0: no wish). One more is drawn first and
 * not counted, because drivers compile in it.
 */
int stats_frames(int frames);

/* Counts a frame; the first one is dropped. */
void stats_add_frame(struct stats *stats, const struct frame_times *times);

/* What came of a tracker; NULL: there was none. */
void stats_add_reports(struct stats *stats, const struct viewer_osc_counts *counts);

/* Times the making of the tables. */
void stats_time_tables(struct stats *stats, const struct show *show);

/*
 * Writes the object, with the scene's counts of the last frame (NULL: 0): to stdout, or to a file
 * beside the wished one that stats_keep then gives its name to, so that a picture that fails in
 * between leaves no statistics behind. Both return false with one line in `message`, MESSAGE_SIZE
 * bytes.
 */
bool stats_write(struct stats *stats, const struct show *show, const struct scene *scene,
                 const char *renderer, char *message);
bool stats_keep(struct stats *stats, char *message);

#endif
