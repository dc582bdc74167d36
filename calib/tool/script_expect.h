/* What a script can expect of the tool. */
#ifndef SCRIPT_EXPECT_H
#define SCRIPT_EXPECT_H

#include "tool/tool.h"

/*
 * The words behind `expect`: NAME VALUE [within T], or warning, notice: containing TEXT or none.
 * False with what was expected and what is there in `message`, MESSAGE_SIZE bytes.
 */
bool script_expect(const struct tool *tool, int count, char *const *words, char *message);

#endif
