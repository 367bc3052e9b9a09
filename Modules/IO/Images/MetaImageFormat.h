#pragma once

#include "ImageFormat.h"

namespace palpate
{
ImageFormat MetaImageFormat();
} // namespace palpate
