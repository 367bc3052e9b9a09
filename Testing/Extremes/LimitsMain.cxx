// PalpateLimits FILE: measures the effect of rounding on difficult fits, and writes the table of
// Documentation/Evidence/Limits.md; see Utilities/limits.sh.
#include "FitPrecision.h"

#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: PalpateLimits FILE.md\n";
    return 2;
  }
  std::ofstream file(argv[1]);
  file << palpate::test::ToMarkdown(palpate::test::MeasureFitPrecision());
  return file.good() ? 0 : 1;
}
