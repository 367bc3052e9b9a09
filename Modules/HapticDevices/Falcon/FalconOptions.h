#pragma once

#include "Status.h"

#include <string>

namespace palpate
{
/// User options of a Falcon, separated by commas, in any order:
///
///     falcon:device=1-2.3,firmware=/home/me/firmware.bin,calibration=/home/me/falcon.txt
struct FalconOptions
{
  std::string Device;          ///< bus path or serial; empty: the first usable one
  std::string FirmwarePath;    ///< empty: the environment's (FalconFirmware::PathOf)
  std::string CalibrationPath; ///< empty: the published values
};

/// Parses the text after "falcon:"; empty text gives the defaults. Fails with a message that names
/// the word that is not understood.
Status ParseFalconOptions(const std::string& text, FalconOptions& options);
} // namespace palpate
