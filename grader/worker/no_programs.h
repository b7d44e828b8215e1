// No other program in the place of the worker.
#pragma once

// From now on execve and execveat fail with EPERM in this process, for good. Does nothing outside the jail,
// where no_new_privs is not set.
void no_programs(void);
