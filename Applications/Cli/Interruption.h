#pragma once

namespace palpate::cli
{
/// While one exists, the first Ctrl-C asks the running command to stop (WasAsked), so that it can
/// leave nothing half-written; the second ends the program at once.
class Interruption
{
public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  static bool WasAsked() noexcept;
};
} // namespace palpate::cli
