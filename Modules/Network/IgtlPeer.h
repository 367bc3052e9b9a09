#pragma once

#include "Status.h"

#include <string>

namespace palpate
{
/// A program that speaks OpenIGTLink.
struct IgtlPeer
{
  std::string Host; ///< empty: the peer, on this machine, connects; "*": it may be anywhere
  int Port = 18944;
  std::string Name; ///< of the TRANSFORM messages; empty: the first that arrive

  bool Connects() const { return this->Host.empty() || this->Host == "*"; }
};

/// The peer that a text names: "", "PORT", "*:PORT", "HOST:PORT", each with "/NAME" at its end.
/// Fails for a port outside 1..65535.
Status ParseIgtlPeer(const std::string& text, IgtlPeer& peer);
} // namespace palpate
