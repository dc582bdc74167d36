/*
 * All of Cupola's core in one line: geometry, plan, GL and the simulated theatre. The file formats
 * (rig_file.h, image_file.h, text.h) are a build option and are included by name.
 */
#ifndef CUPOLA_CUPOLA_H
#define CUPOLA_CUPOLA_H

#include "antialiasing.h"
#include "cost.h"
#include "dome.h"
#include "error.h"
#include "gl.h"
#include "gl_params.h"
#include "jitter.h"
#include "lens.h"
#include "log.h"
#include "one_pass.h"
#include "overlay.h"
#include "plan.h"
#include "points.h"
#include "projection.h"
#include "reference.h"
#include "resolution.h"
#include "rig.h"
#include "source.h"
#include "theatre.h"
#include "version.h"
#include "viewer.h"

#endif
