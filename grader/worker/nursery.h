// A worker that knows no lab yet: it has a context and our own shaders, and forks a child for each order. No
// code and no byte of a submission is ever in it, so that what a child finds is the same for all.
#pragma once

#include <stdbool.h>
#include <stddef.h>

// Takes orders (protocol/nursery_order.h) until the socket closes: then false. True in each child, which is
// in a jail of its own: there `folder` names the lab, and the descriptors are those of a worker. It sees the
// `count` paths beside it.
bool nursery_wait(char *folder, size_t size, char *const *paths, int count);
