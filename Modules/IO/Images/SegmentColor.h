#pragma once

#include "PalpateIOModule.h"

#include <array>
#include <cstdint>

namespace palpate
{
/// Default colour (red, green, blue, 0..1) of a structure: label 1 has Segment's default, the
/// others follow on the colour circle in steps of the golden angle, so that consecutive labels
/// differ.
PALPATEIO_EXPORT std::array<double, 3> DefaultSegmentColor(int label);

/// sRGB (0..1, clamped) of a colour in DICOM's 16-bit CIELab encoding: L* 0..100 and a*, b*
/// -128..127 spread over 0..65535 (PS3.3, C.10.7.1.1). The white point is D65: the standard's
/// profile connection space has D50, but DCMTK, dcmqi and 3D Slicer encode under D65, so that
/// colours are read as they were chosen there.
PALPATEIO_EXPORT std::array<double, 3>
CieLabToRgb(const std::array<std::uint16_t, 3>& encoded) noexcept;

/// The same colour encoded.
PALPATEIO_EXPORT std::array<std::uint16_t, 3>
RgbToCieLab(const std::array<double, 3>& rgb) noexcept;
} // namespace palpate
