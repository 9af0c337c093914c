// SPDX-License-Identifier: BSD-3-Clause
// The report of a reproduction: who its searches found, and why one cannot be read.
#include "optimizer/report/reproduction_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace k3d::optimizer::report {
namespace {

using testing::HasSubstr;

TEST(ReproductionPage, ListsWhatCannotBeRead) {
    Reproduction reproduction;
    SearchReport search;
    search.search = {"kick", "fig2", "Kick by CMA-ES"};
    search.run = 2;
    search.fault = "exp.toml:3: unknown key \"parameters.kick.old\"";
    reproduction.searches.push_back(search);
    EXPECT_THAT(reproduction_text(reproduction), HasSubstr("Kick by CMA-ES, run 2"));
    EXPECT_THAT(reproduction_text(reproduction), HasSubstr("cannot be read: exp.toml:3: unknown key"));
    EXPECT_THAT(searches_csv(reproduction),
                HasSubstr("\n\"kick\",\"2\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"cannot be read: "
                          "exp.toml:3: unknown key \"\"parameters.kick.old\"\"\"\n"));
    EXPECT_THAT(reproduction_html(reproduction), HasSubstr("cannot be read: exp.toml:3"));
}

TEST(ReproductionPage, NamesTheChampionBelowItsSearchAndTheVersionUntilThereIsOne) {
    Reproduction reproduction;
    SearchReport search;
    search.search = {"kick", "fig2", "Kick by CMA-ES"};
    search.version = "0.1.0+abc";
    reproduction.searches.push_back(search);
    EXPECT_THAT(reproduction_html(reproduction),
                HasSubstr("<td>no</td></tr>\n"
                          "<tr class=\"dim\"><td colspan=\"10\">version 0.1.0+abc</td></tr>\n"));
    reproduction.searches[0].champion = "candidate 3 of run kick, version 0.1.0+abc";
    EXPECT_THAT(reproduction_html(reproduction),
                HasSubstr("<td colspan=\"10\">candidate 3 of run kick, version 0.1.0+abc</td>"));
}

}  // namespace
}  // namespace k3d::optimizer::report
