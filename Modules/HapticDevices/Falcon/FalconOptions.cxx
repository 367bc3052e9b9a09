#include "FalconOptions.h"

#include <sstream>

namespace palpate
{
Status ParseFalconOptions(const std::string& text, FalconOptions& options)
{
  FalconOptions found;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
  {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    std::string* const value = name == "device"        ? &found.Device
                               : name == "firmware"    ? &found.FirmwarePath
                               : name == "calibration" ? &found.CalibrationPath
                                                       : nullptr;
    if (value == nullptr || equals == std::string::npos || equals + 1 == word.size())
    {
      return Status::Failure("\"" + word +
                             "\" is not understood: a Falcon takes device=, "
                             "firmware= and calibration=, separated by commas.");
    }
    *value = word.substr(equals + 1);
  }
  options = found;
  return Status::Success();
}
} // namespace palpate
