#pragma once

#include "TouchRecording.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// File format of recordings: a line that names the format, then words of 64 bits, little endian:
/// those of the session, and those of each tick. Doubles are stored as their IEEE 754 bits, so that
/// they are read back exactly.
namespace TouchRecordingFormat
{
inline constexpr char Magic[] = "palpate-touch-recording 6\n";
/// Without the session's largest torque, and torque and orientations of each tick.
inline constexpr char Magic5[] = "palpate-touch-recording 5\n";
/// Like 5, without the session's word on motors: every device has motors.
inline constexpr char Magic4[] = "palpate-touch-recording 4\n";
/// Of 0.1.0: like 4, but flags have bits from 48 up, which are skipped, and the last words of a
/// tick, which describe structures that yield, are missing.
inline constexpr char Magic3[] = "palpate-touch-recording 3\n";
inline constexpr std::size_t MagicSize = sizeof(Magic) - 1;
/// Index of the word that holds flags, in a tick.
inline constexpr std::size_t FlagsWord = 5;
inline constexpr std::uint64_t SkippedFlags3 = ~std::uint64_t{0} << 48;
inline constexpr std::size_t SessionWords = 15;
inline constexpr std::size_t SessionWords5 = 14;
inline constexpr std::size_t SessionWords4 = 13; ///< of versions 3 and 4
inline constexpr std::size_t TickWords = 50;
inline constexpr std::size_t TickWords5 = 39; ///< of versions 4 and 5
inline constexpr std::size_t TickWords3 = 37;

using SessionRecord = std::array<std::uint64_t, SessionWords>;
using TickRecord = std::array<std::uint64_t, TickWords>;

SessionRecord Encode(const RecordedSession& session) noexcept;
TickRecord Encode(const TouchState& state) noexcept;
/// Returns false if the words are not a valid session.
bool Decode(const SessionRecord& words, RecordedSession& session) noexcept;
/// Returns false if the words are not a valid tick.
bool Decode(const TickRecord& words, TouchState& state) noexcept;
} // namespace TouchRecordingFormat
} // namespace palpate
