// What a frame costs on any machine, counted while a worker of its own draws it (worker/counted.h).
#pragma once

#include "study/lab_artist.h"
#include "study/measurements.h"

#include <stdbool.h>

// Counts reads, fragments and cleared texels of the request's second frame, as times are taken: what a lab
// keeps from the first one costs nothing. Of a submission that cannot be counted they stay 0. False with a
// message when a lab of ours does not draw so.
bool counted_frame(LabArtist *artist, const Request *request, MeasuredErrors *errors);
