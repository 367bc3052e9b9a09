#include "IgtlPeer.h"

#include "DecimalText.h"

#include <optional>

namespace palpate
{
Status ParseIgtlPeer(const std::string& text, IgtlPeer& peer)
{
  IgtlPeer parsed;
  const std::size_t slash = text.find('/');
  const std::string address = text.substr(0, slash);
  parsed.Name = slash == std::string::npos ? "" : text.substr(slash + 1);
  const std::size_t colon = address.rfind(':');
  parsed.Host = colon == std::string::npos ? "" : address.substr(0, colon);
  const std::string port = colon == std::string::npos ? address : address.substr(colon + 1);
  constexpr int LargestPort = 65535;
  if (!port.empty())
  {
    const std::optional<int> number = ParseInteger(port);
    if (!number || *number < 1 || *number > LargestPort)
    {
      return Status::Failure("'" + text +
                             "' is no OpenIGTLink peer: use PORT, *:PORT or HOST:PORT, " +
                             "with /NAME for the tool's name.");
    }
    parsed.Port = *number;
  }
  peer = parsed;
  return Status::Success();
}
} // namespace palpate
