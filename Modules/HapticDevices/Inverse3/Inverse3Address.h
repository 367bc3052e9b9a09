#pragma once

#include "Status.h"

#include <string>

namespace palpate
{
/// Which Inverse3, and where its service listens. The service is on this machine: a force over a
/// network would come too late.
struct Inverse3Address
{
  std::string Id;        ///< of the device; empty: the first one
  int Port = 10001;      ///< of states and commands
  int EventPort = 10020; ///< of what happens to devices

  /// From "", "ID", or "port=N", "events=N" and "id=ID" with commas in between.
  static Status Parse(const std::string& text, Inverse3Address& address);
};
} // namespace palpate
