#include "MaskRuns.h"

namespace palpate
{
RunSet RunsOf(const VoxelMask& mask)
{
  RunSet runs;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      const unsigned char* const row = mask.Inside.data() + mask.Offset(0, j, k);
      const unsigned char* const end = row + mask.Size[0];
      for (const unsigned char* first = std::find(row, end, 1); first != end;)
      {
        const unsigned char* const behind = std::find(first, end, 0);
        runs.Add({static_cast<int>(first - row), static_cast<int>(behind - row)}, j, k);
        first = std::find(behind, end, 1);
      }
    }
  }
  return runs;
}
} // namespace palpate
