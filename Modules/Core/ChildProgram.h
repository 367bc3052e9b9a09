#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace palpate
{
/// Starts one of the project's own programs, looked for in this order: next to the running program,
/// in the folder `bin` next to the libraries' (or to its parent), on the PATH. It has its own
/// session, so no signal of a terminal reaches it, and of this process's files only `input`, as its
/// standard input; what it prints is dropped. Returns its process id, -1 if it cannot be started.
pid_t StartChildProgram(const std::string& name, const std::vector<std::string>& arguments,
                        int input);

void WaitForChildProgram(pid_t process) noexcept;
} // namespace palpate
