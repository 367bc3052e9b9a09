#include "DeviceOption.h"

#include <sstream>

namespace palpate
{
std::string WithDeviceOption(const std::string& device, const std::string& option,
                             const std::string& value)
{
  const std::size_t colon = device.find(':');
  std::istringstream words(colon == std::string::npos ? "" : device.substr(colon + 1));
  std::string text = device.substr(0, colon) + ":";
  for (std::string word; std::getline(words, word, ',');)
  {
    text += word.rfind(option + "=", 0) == 0 ? "" : word + ",";
  }
  return text + option + "=" + value;
}
} // namespace palpate
