#pragma once

#include <string>

namespace palpate
{
/// A device's text ("name" or "name:option=value,option=value") with an option set to a value,
/// replacing any earlier one. Values must not contain commas.
std::string WithDeviceOption(const std::string& device, const std::string& option,
                             const std::string& value);
} // namespace palpate
