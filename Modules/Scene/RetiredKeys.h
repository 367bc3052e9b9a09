#pragma once

#include <initializer_list>

namespace palpate
{
/// JSON keys of earlier versions that no longer have a meaning. They are skipped when a file is
/// read (JsonFields::Skip) and never written.
namespace RetiredKeys
{
inline constexpr std::initializer_list<const char*> Scene{"memory_mb"}; ///< 0.1.0
inline constexpr std::initializer_list<const char*> SceneStructure{"precision",
                                                                   "brick_cells"}; ///< 0.1.0
} // namespace RetiredKeys
} // namespace palpate
