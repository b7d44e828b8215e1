// Raw mode and the other screen, entered and left on every way out (signals, stop and go on), and keys and
// events one by one.
#include "watch/terminal.h"

#include "base/color.h"
#include "scene/check.h"
#include "scene/count.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

static const char enter_screen[] = "\033[?1049h\033[?25l\033[2J";
static const char leave_screen[] = "\033[?25h\033[?1049l";
static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
static const int fatal[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};
enum { ENDING = COUNT(ending), FATAL = COUNT(fatal) };

static struct termios before;
static sigset_t mask_before;
static volatile sig_atomic_t is_open, ended_by, resized, stopped;
static unsigned char typed[64]; // keys read and not yet handed out
static int typed_count;

static void put(const char *text, size_t size) {
    while (size > 0) {
        ssize_t n = write(STDOUT_FILENO, text, size);
        if (n < 0 && errno != EINTR)
            return;
        text += n > 0 ? n : 0;
        size -= n > 0 ? (size_t)n : 0;
    }
}

static void enter(void) {
    struct termios raw = before;
    raw.c_lflag &= (tcflag_t) ~(ICANON | ECHO);
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSADRAIN, &raw);
    put(enter_screen, sizeof enter_screen - 1);
    is_open = 1;
}

static void leave(void) {
    if (!is_open)
        return;
    is_open = 0;
    put(leave_screen, sizeof leave_screen - 1);
    tcsetattr(STDIN_FILENO, TCSADRAIN, &before);
}

static void on_signal(int number) {
    if (number == SIGWINCH || number == SIGCONT)
        resized = 1;
    else if (number == SIGTSTP)
        stopped = 1;
    else
        ended_by = number;
}

// A fault of ours: the terminal is put back, then the signal does what it always does (SA_RESETHAND).
static void on_fatal(int number) {
    leave();
    raise(number);
}

static void handle(int number, void (*handler)(int), int flags) {
    struct sigaction action = {.sa_flags = flags};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, NULL);
}

// The signals that are awaited reach us only inside terminal_wait.
static void catch_all(void) {
    const int awaited[] = {SIGWINCH, SIGCONT, SIGTSTP};
    sigset_t mask;
    sigemptyset(&mask);
    for (int i = 0; i < ENDING; i++) {
        handle(ending[i], on_signal, 0);
        sigaddset(&mask, ending[i]);
    }
    for (int i = 0; i < 3; i++) {
        handle(awaited[i], on_signal, 0);
        sigaddset(&mask, awaited[i]);
    }
    for (int i = 0; i < FATAL; i++)
        handle(fatal[i], on_fatal, SA_RESETHAND | SA_NODEFER);
    sigprocmask(SIG_BLOCK, &mask, &mask_before);
}

void terminal_forget(void) {
    is_open = 0;
    for (int i = 0; i < ENDING; i++)
        handle(ending[i], SIG_DFL, 0);
    for (int i = 0; i < FATAL; i++)
        handle(fatal[i], SIG_DFL, 0);
    handle(SIGWINCH, SIG_DFL, 0);
    handle(SIGCONT, SIG_DFL, 0);
    handle(SIGTSTP, SIG_DFL, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

bool terminal_open(void) {
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO) || tcgetattr(STDIN_FILENO, &before) != 0)
        return check_fail("this is not a terminal, so there are no keys and nothing is graded on save");
    if (color_is_dumb())
        return check_fail(
            "this terminal only goes on line by line (TERM is \"dumb\"), so there is no screen to draw on");
    catch_all();
    enter();
    return true;
}

void terminal_close(void) {
    const int by = ended_by;
    if (!is_open)
        return;
    leave();
    terminal_forget();
    if (by)
        raise(by);
}

// Ctrl-Z: the shell gets its screen back until we go on.
static void stop(void) {
    stopped = 0;
    leave();
    handle(SIGTSTP, SIG_DFL, 0);
    sigset_t mask;
    sigemptyset(&mask);
    sigaddset(&mask, SIGTSTP);
    raise(SIGTSTP);
    sigprocmask(SIG_UNBLOCK, &mask, NULL); // here we stand still
    sigprocmask(SIG_BLOCK, &mask, NULL);
    handle(SIGTSTP, on_signal, 0);
    enter();
    resized = 1;
}

static int drop_typed(int count, int key) {
    typed_count -= count;
    memmove(typed, typed + count, (size_t)typed_count);
    return key;
}

// The next key; sequences that we do not know are swallowed.
static int take_key(void) {
    if (typed_count == 0)
        return KEY_NONE;
    if (typed[0] == '\r')
        return drop_typed(1, KEY_ENTER);
    if (typed[0] != KEY_ESCAPE || typed_count == 1)
        return drop_typed(1, typed[0]);
    const bool arrow = typed_count >= 3 && (typed[1] == '[' || typed[1] == 'O');
    const int last = typed[2];
    if (arrow && (last == 'A' || last == 'B'))
        return drop_typed(3, last == 'A' ? KEY_UP : KEY_DOWN);
    return drop_typed(typed_count, KEY_NONE);
}

Event terminal_wait(int descriptor, int milliseconds) {
    struct pollfd events[2] = {{.fd = STDIN_FILENO, .events = POLLIN}, {.fd = descriptor, .events = POLLIN}};
    const struct timespec time = {milliseconds / 1000, milliseconds % 1000 * 1000000L};
    Event event = {0};
    if (typed_count == 0 && ppoll(events, 2, &time, &mask_before) > 0) {
        if (events[0].revents) {
            ssize_t n = read(STDIN_FILENO, typed, sizeof typed);
            event.end = n <= 0 && errno != EINTR;
            typed_count = n > 0 ? (int)n : 0;
        }
        event.readable = events[1].revents != 0;
    }
    if (stopped)
        stop();
    event.key = take_key();
    event.redraw = resized;
    event.end = event.end || ended_by;
    resized = 0;
    return event;
}

void terminal_size(int *columns, int *rows) {
    struct winsize size = {0};
    const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
    *columns = known ? size.ws_col : 80;
    *rows = known ? size.ws_row : 24;
}
