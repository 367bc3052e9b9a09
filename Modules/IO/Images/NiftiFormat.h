#pragma once

#include "ImageFormat.h"

namespace palpate
{
ImageFormat NiftiFormat();
} // namespace palpate
