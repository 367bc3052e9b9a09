#pragma once

#include "TouchRecording.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// How recordings lie in files: a line that names the format, then words of 64 bits, least byte
/// first: those of the session, and those of each tick. Doubles are their IEEE 754 bits, so that
/// what is read is what was written to the last bit.
namespace TouchRecordingFormat
{
inline constexpr char Magic[] = "palpate-touch-recording 3\n";
inline constexpr std::size_t MagicSize = sizeof(Magic) - 1;
inline constexpr std::size_t SessionWords = 13;
inline constexpr std::size_t TickWords = 37;

using SessionRecord = std::array<std::uint64_t, SessionWords>;
using TickRecord = std::array<std::uint64_t, TickWords>;

SessionRecord Encode(const TouchSession& session) noexcept;
TickRecord Encode(const TouchState& state) noexcept;
/// False where the words are none of a session.
bool Decode(const SessionRecord& words, TouchSession& session) noexcept;
/// False where the words are none of a tick.
bool Decode(const TickRecord& words, TouchState& state) noexcept;
} // namespace TouchRecordingFormat
} // namespace palpate
