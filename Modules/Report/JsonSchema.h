#pragma once

namespace palpate
{
/// Version of the keys that Documentation/JsonOutput.md lists: of every `--json`, of `summary.json`
/// and of `tradeoff.json`. Raised when a key is removed or changes its name, unit or meaning, not
/// when one is added.
inline constexpr int JsonSchemaVersion = 4;
/// The key of the version, first in every object.
inline constexpr const char* JsonSchemaKey = "schema_version";
} // namespace palpate
