// The terminal: keys one by one, a screen of our own, and everything as it was before when we end, however
// that comes about.
#pragma once

#include <stdbool.h>

enum { KEY_NONE = 0, KEY_ENTER = '\n', KEY_ESCAPE = 27, KEY_UP = 256, KEY_DOWN };

typedef struct Event {
    int key;       // a character or KEY_...; KEY_NONE when none was pressed
    bool readable; // there is something to read from the descriptor
    bool redraw;   // the size has changed, or we were stopped and go on
    bool end;      // a signal asks us to end, or the terminal is gone
} Event;

// False with a message that says what to do, when standard input and output are not a terminal.
bool terminal_open(void);

// Puts everything back; when a signal asked us to end, we end by it now.
void terminal_close(void);

// In a child process: signals act as usual, and the terminal is not ours to restore.
void terminal_forget(void);

// Waits for something, at most `milliseconds`; `descriptor` may be -1.
Event terminal_wait(int descriptor, int milliseconds);

// The size in characters, at least 1 x 1; 80 x 24 when unknown.
void terminal_size(int *columns, int *rows);
