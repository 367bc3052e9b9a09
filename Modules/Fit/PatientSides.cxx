#include "PatientSides.h"

namespace palpate
{
const std::array<PatientSide, 6>& PatientSides()
{
  static const std::array<PatientSide, 6> sides{{{"left", Vector3::UnitX()},
                                                 {"right", -Vector3::UnitX()},
                                                 {"posterior", Vector3::UnitY()},
                                                 {"anterior", -Vector3::UnitY()},
                                                 {"superior", Vector3::UnitZ()},
                                                 {"inferior", -Vector3::UnitZ()}}};
  return sides;
}
} // namespace palpate
