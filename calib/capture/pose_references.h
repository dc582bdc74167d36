/* The references of a camera of unknown pose: what they must be, and whether they fit. */
#ifndef POSE_REFERENCES_H
#define POSE_REFERENCES_H

#include "capture/pose.h"

/*
 * Before anything is solved: whether they are in the photograph, and far enough apart. False with
 * one line in `message`, MESSAGE_SIZE bytes.
 */
bool pose_references_check(const struct pose_request *request, char *message);

/*
 * How far each is from where a camera sees its point, px of the photograph, into `off_px`; returns
 * their rms without the one of index `left_out` (-1: of all).
 */
double pose_references_measure(const struct pose_request *request, const struct camera *camera,
                               int left_out, double *off_px);

/* Beyond this rms they are wrong: nobody points at places so badly. */
double pose_references_allowed_px(const struct camera *camera);

/* The refusal; `wrong` is the only one without which the others fit, to `rest_px`, or -1. */
void pose_references_refuse(const struct pose_request *request, const double *off_px, double rms_px,
                            int wrong, double rest_px, char *message);

#endif
