// PalpateStability FILE: measures the largest stable stiffness of structures, and writes it as
// JSON; see Utilities/stability.sh.
#include "StabilityBorders.h"

#include <exception>
#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: PalpateStability FILE.json\n";
    return 2;
  }
  try
  {
    const auto borders = palpate::bench::MeasureStability(
        [](int done, int all) { std::cerr << '\r' << done << " of " << all << std::flush; });
    std::cerr << '\n';
    std::ofstream file(argv[1]);
    file << palpate::bench::ToJson(borders) << '\n';
    return file.good() ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
