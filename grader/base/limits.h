// How much a course may hold: every bound of what a lecturer writes, once. Whoever keeps an array of such
// things takes its size from here, and rubric_load refuses what is larger. Names and texts: bytes in UTF-8.
#pragma once

enum {
    COURSE_MAX_LABS = 40,

    // Of a lab. What a lab.c may hold stands in common/lab.h.
    RUBRIC_MAX_FILES = 8,
    RUBRIC_MAX_CHECKS = 16,
    EXAM_MAX_VARIANTS = 8,
    EXAM_MAX_TASKS = 32, // more than the highest number M of a task N.M
    EXAM_MAX_MISTAKES = 64,
    EXAM_MAX_ALTERNATIVES = 40,
    EXAM_MAX_PARTS = 48,   // functions of a lab's files, see compile/parts.h
    EXAM_MAX_RESETS = 512, // versions of our lab with one or two of them as they were handed out
    RUBRIC_MAX_EDITS = 6,  // of a mistake or an alternative
    CHANGE_MAX_EDITS = 2 * RUBRIC_MAX_EDITS, // of one that is put together from two
    RUBRIC_MAX_HINTS = 9,                    // of a task
    RUBRIC_MAX_POINTS = 1000,
    RUBRIC_MAX_CHOICES = 6, // of a knob or of a check's scenes
    RUBRIC_MAX_PREDICTIONS = 4,
    RUBRIC_MAX_ALSO = 4, // alternatives whose other pictures are right, too

    RUBRIC_MAX_FILE = 1 << 20, // of rubric.json and the others
    RUBRIC_MAX_TITLE = 60,
    RUBRIC_MAX_NAME = 80, // of a check, mistake, alternative, scene or file
    RUBRIC_MAX_HINT = 1400,
    RUBRIC_MAX_EDIT = 1 << 14, // the text of an edit

    // Of what is told when a lab is done.
    AFTERWORD_QUESTIONS = 3,   // of the handout: no more and no fewer
    AFTERWORD_MAX_ABOUT = 60,  // what a question is about
    AFTERWORD_MAX_PARTS = 6,   // of an answer, or things to try
    AFTERWORD_MAX_TEXT = 1400, // of a part

    // All that is drawn for one lab: the solution, the skeleton, the solution without the task of a check,
    // the lab solved up to each task, with each mistake, each alternative, and with parts as handed out.
    EXAM_MAX_PAINTERS =
        2 + RUBRIC_MAX_CHECKS + EXAM_MAX_TASKS + EXAM_MAX_MISTAKES + EXAM_MAX_ALTERNATIVES + EXAM_MAX_RESETS
};
