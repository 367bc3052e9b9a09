#pragma once

#include "ImageFormat.h"

namespace palpate
{
ImageFormat NrrdFormat();
} // namespace palpate
