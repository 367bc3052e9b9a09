#pragma once

#include "Status.h"

#include <string>

namespace palpate
{
/// What a user says of a Falcon, as words separated by commas, in any order:
///
///     falcon:device=1-2.3,firmware=/home/me/firmware.bin,calibration=/home/me/falcon.txt
struct FalconOptions
{
  std::string Device;          ///< bus path or serial; empty: the first usable one
  std::string FirmwarePath;    ///< empty: what the environment names (FalconFirmware::PathOf)
  std::string CalibrationPath; ///< empty: the published values
};

/// Of what stands behind "falcon:"; empty text is the defaults. Fails with a sentence that names
/// the word that is not understood.
Status ParseFalconOptions(const std::string& text, FalconOptions& options);
} // namespace palpate
