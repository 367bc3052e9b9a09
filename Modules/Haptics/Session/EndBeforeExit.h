#pragma once

#include <functional>

namespace palpate
{
/// A function that must run before the process ends, whatever ends it: while one exists, a call of
/// exit(), as by an X library whose server has gone, first calls the function, and more repetitions
/// of an Interruption are needed to end the process at once. For a device that pushes a hand: 0 N,
/// then closed.
///
/// For the thread that calls main.
class EndBeforeExit
{
public:
  /// `end` must not throw.
  explicit EndBeforeExit(std::function<void()> end);
  EndBeforeExit(const EndBeforeExit&) = delete;
  EndBeforeExit& operator=(const EndBeforeExit&) = delete;
  /// Normal end: the function is not called.
  ~EndBeforeExit();

  /// Whether one exists. May be called by signal handlers.
  static bool IsInForce() noexcept;

private:
  static void EndAll();

  std::function<void()> End;
};
} // namespace palpate
