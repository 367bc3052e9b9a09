#pragma once

#include <functional>

namespace palpate
{
/// What has to be done before the process ends, whoever ends it: while one exists, a call of
/// exit(), as of an X library whose server has gone, first calls its function, and a repeated
/// Interruption ends the process at once only where it is repeated often. For a device that pushes
/// a hand: 0 N, then closed.
///
/// For the thread that calls main.
class EndBeforeExit
{
public:
  /// `end` must not throw.
  explicit EndBeforeExit(std::function<void()> end);
  EndBeforeExit(const EndBeforeExit&) = delete;
  EndBeforeExit& operator=(const EndBeforeExit&) = delete;
  /// All has ended as usual: nothing is called.
  ~EndBeforeExit();

  /// Whether one exists. May be called by signal handlers.
  static bool IsInForce() noexcept;

private:
  static void EndAll();

  std::function<void()> End;
};
} // namespace palpate
