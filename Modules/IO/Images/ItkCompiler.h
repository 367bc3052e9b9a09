#pragma once

// Debian's ITK describes only the compiler that it was built with, and its headers refuse all
// others. This is what they use of that description, for Clang; included before them.
#ifdef __clang__
#define ITK_COMPILER_DETECTION_H
#define VXL_COMPILER_DETECTION_H
#define ITK_CONSTEXPR constexpr
#define ITK_NOEXCEPT noexcept
#define ITK_DEPRECATED_MSG(text) [[deprecated(text)]]
#define VXL_DEPRECATED_MSG(text) [[deprecated(text)]]
#endif
