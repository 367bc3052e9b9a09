#pragma once

#include "ImageFormat.h"

namespace palpate
{
/// FreeSurfer's volumes; read only.
ImageFormat MghFormat();
} // namespace palpate
