#pragma once

#include "JsonFields.h"
#include "PalpateSceneModule.h"
#include "SceneSettings.h"

namespace palpate
{
/// Reads or writes the entries of a scene in an object of a scene file or a session: "structures",
/// "fit", "tool", "drill", "device", "rate_hz", "model_interval", "placement". Names of numbers end
/// with the unit; missing entries keep their values. Throws InputError.
PALPATESCENE_EXPORT void ExchangeScene(JsonFields& fields, SceneSettings& scene);
} // namespace palpate
