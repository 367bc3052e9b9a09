// PalpateExaminer FILE [SEARCHES]: lets the virtual examiner search phantoms with and without
// nodules, and writes what it finds as JSON; see Utilities/examiner.sh.
#include "DecimalText.h"
#include "ExaminerTable.h"

#include <exception>
#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
  constexpr int DefaultSearches = 400;
  const std::optional<int> searches =
      argc == 3 ? palpate::ParseInteger(argv[2]) : std::optional<int>(DefaultSearches);
  if (argc < 2 || argc > 3 || !searches || *searches < 1)
  {
    std::cerr << "usage: PalpateExaminer FILE.json [SEARCHES]\n";
    return 2;
  }
  try
  {
    const auto rows = palpate::test::MeasureExaminer(
        *searches,
        [](int done, int all) { std::cerr << '\r' << done << " of " << all << std::flush; });
    std::cerr << '\n';
    std::ofstream file(argv[1]);
    file << palpate::test::ToJson(rows) << '\n';
    return file.good() ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
