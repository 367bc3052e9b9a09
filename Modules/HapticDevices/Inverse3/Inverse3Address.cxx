#include "Inverse3Address.h"

#include "DecimalText.h"

namespace palpate
{
namespace
{
bool TakePort(const std::string& text, int& port)
{
  constexpr int Largest = 65535;
  const int given = ParseInteger(text).value_or(0);
  port = given;
  return given >= 1 && given <= Largest;
}
} // namespace

Status Inverse3Address::Parse(const std::string& text, Inverse3Address& address)
{
  Inverse3Address parsed;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string item = text.substr(at, end - at);
    const std::size_t equals = item.find('=');
    const std::string name = equals == std::string::npos ? "id" : item.substr(0, equals);
    const std::string value = equals == std::string::npos ? item : item.substr(equals + 1);
    const bool isTaken = name == "port"     ? TakePort(value, parsed.Port)
                         : name == "events" ? TakePort(value, parsed.EventPort)
                         : name == "id"     ? !(parsed.Id = value).empty()
                                            : false;
    if (!isTaken)
    {
      return Status::Failure("An Inverse3 is named as inverse3[:ID], or by id=ID, port=N and "
                             "events=N with commas in between, not by " +
                             item + ".");
    }
    at = end + 1;
  }
  address = parsed;
  return Status::Success();
}
} // namespace palpate
