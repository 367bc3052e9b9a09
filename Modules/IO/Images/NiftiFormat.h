#pragma once

#include "ImageFormat.h"

namespace palpate
{
/// NIfTI-1 and NIfTI-2 in one file.
ImageFormat NiftiFormat();
/// The header of NIfTI or Analyze 7.5 in two files; read only.
ImageFormat NiftiPairFormat();
} // namespace palpate
