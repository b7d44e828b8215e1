// What a scene needs: the cheapest setting that is enough in all its views, and how sure that is.
#pragma once

#include "study/finding.h"

// From errors and times to front, enough and chosen.
void findings_judge(SceneFindings *findings);

// The finding that is chosen; NULL when none is enough.
const Finding *findings_chosen(const SceneFindings *findings);

// Which one would be chosen if all limits (FINDING_MOST_OFF, the scene's tolerance) were multiplied by
// `scale`, and if only this view counted (-1: all count)? Of those that take the same time within
// the noise, the one with the fewest texels, rays, fragments and taps, and then the smallest error. -1: none
// is enough.
int findings_choose(const SceneFindings *findings, double scale, int view);

// The most expensive one of the front that is cheaper than the chosen one and not enough; NULL when there is
// none.
const Finding *findings_next_cheaper(const SceneFindings *findings);

// One line: what this scene needs, by which margin and what else costs the same, what the next cheaper
// setting gets wrong, and on which limits, views and size that hangs.
void findings_tell(const SceneFindings *findings, char *text, size_t size);

enum { VERDICT_TEXT = 1024 }; // room for that line
