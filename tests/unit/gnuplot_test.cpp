// The program that draws every figure, as it is called and as it fails.
#include "core/gnuplot.hpp"

#include <gtest/gtest.h>
#include <sys/time.h>

#include <csignal>
#include <cstdlib>

#include "support/scratch.hpp"

namespace ifedem {
namespace {

volatile std::sig_atomic_t alarms = 0;
extern "C" void count_alarm(int) { alarms = alarms + 1; }

TEST(Gnuplot, TellsHowItEnded) {
    const Scratch scratch;
    EXPECT_EQ(execute_gnuplot({"-e", "print 'said'"}, scratch.file("log")), 0);
    EXPECT_EQ(read_text(scratch.file("log")), "said\n");
    EXPECT_NE(execute_gnuplot({scratch.file("no-script.gp")}, scratch.file("log")), 0);
    const std::string old_path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    EXPECT_EQ(execute_gnuplot({"-e", "print 1"}), 127);
    setenv("PATH", old_path.c_str(), 1);
}

TEST(Gnuplot, IsWaitedForThroughSignals) {
    struct sigaction action {
    }, before{};
    action.sa_handler = count_alarm;  // no SA_RESTART
    sigaction(SIGALRM, &action, &before);
    const itimerval often{{0, 20'000}, {0, 20'000}}, never{};
    setitimer(ITIMER_REAL, &often, nullptr);
    const int status = execute_gnuplot({"-e", "pause 0.3"});
    setitimer(ITIMER_REAL, &never, nullptr);
    sigaction(SIGALRM, &before, nullptr);
    EXPECT_GT(alarms, 1);
    EXPECT_EQ(status, 0);
}

TEST(Gnuplot, TakesAnyTextAsAString) {
    EXPECT_EQ(quote_for_gnuplot("it's"), "'it''s'");
    EXPECT_EQ(quote_for_gnuplot("two\nlines"), "'two lines'");
}

}  // namespace
}  // namespace ifedem
