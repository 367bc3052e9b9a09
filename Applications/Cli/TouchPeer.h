#pragma once

#include "IgtlLink.h"
#include "TouchRun.h"

#include <string>

namespace palpate::cli
{
class Console;

/// Another program that displays a touch while it runs, by OpenIGTLink: `palpate touch --igtl`. It
/// gets the surfaces of the scene, and where the tool is (IgtlTouchMessages). The touch never waits
/// for it.
class TouchPeer
{
public:
  /// Waits for the program, or connects to it (see ParseIgtlPeer). Throws InputError if the port is
  /// taken or nobody waits there, and if a surface cannot be made.
  TouchPeer(const std::string& address, const PreparedTouch& touch, Console& console);
  TouchPeer(const TouchPeer&) = delete;
  TouchPeer& operator=(const TouchPeer&) = delete;
  /// Tells it that the touch has ended.
  ~TouchPeer();

  void Show(const TouchState& newest);

private:
  void TellProblems();

  Console& Screen;
  IgtlLink Link;
};
} // namespace palpate::cli
