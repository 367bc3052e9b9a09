#pragma once

#include "ImageFormat.h"

namespace palpate
{
/// Guy's Image Processing Lab format; read only.
ImageFormat GiplFormat();
} // namespace palpate
