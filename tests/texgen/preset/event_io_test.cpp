// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/event_io.h"

#include "tests/texgen/preset/rejection.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// Assigns all values of `set` at once, as a command line does.
std::string failure(const std::string& toml, const std::vector<std::string>& set = {}) {
    return test::rejection_of([&] {
        Preset preset = parse_preset(toml, "a", "a.toml");
        std::vector<Assignment> assignments;
        for (const std::string& argument : set) {
            assignments.push_back(read_set_argument(argument));
        }
        assign(preset, assignments);
    });
}

std::string allowed_kinds() {
    return find_key(event_keys(), "kind")->allowed;
}

std::vector<Event> events(const std::string& toml) {
    return parse_preset(toml, "a", "a.toml").events;
}

TEST(EventIo, ReadsEventsInTheOrderOfTheFile) {
    const std::vector<Event> read = events(
        "[[event]]\nkind = \"collapse\"\nframes = [5, 8]\nsides = [4, 5]\ncount = 3\n"
        "order = \"in-turn\"\n"
        "[foam]\nbubbles = 50\n"
        "[[event]]\nframe = 3\nkind = \"nucleate\"\nat = [0.25, 1]\non = \"film\"\narea = 0.3\n"
        "[[event]]\nkind = \"drive\"\nframes = [2, 49]\namplitude = 0.2\nperiod = 12\n"
        "phases = \"random\"\n");
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read[0].kind, "collapse");
    EXPECT_EQ(read[0].frames, (FrameSpan{5, 8}));
    EXPECT_EQ(read[0].sides, (std::vector{4, 5}));
    EXPECT_EQ(read[0].count, 3);
    EXPECT_EQ(read[0].collapse.order, EventOrder::InTurn);
    EXPECT_EQ(read[1].kind, "nucleate");
    EXPECT_EQ(read[1].frames, (FrameSpan{3, 3}));
    EXPECT_DOUBLE_EQ(read[1].at->front(), 0.25);
    EXPECT_DOUBLE_EQ(read[1].at->back(), 1.0);
    EXPECT_EQ(read[1].nucleate.on, NucleationSite::Film);
    EXPECT_EQ(read[2].kind, "drive");
    EXPECT_DOUBLE_EQ(read[2].drive.period, 12.0);
    EXPECT_EQ(read[2].drive.phases, Phases::Random);
}

TEST(EventIo, ALoneBubbleNeedsNoList) {
    const std::vector<Event> read =
        events("[[event]]\nkind = \"collapse\"\nframe = 2\nbubble = 7\n");
    EXPECT_EQ(read[0].bubbles, (std::vector<BubbleIdentity>{7}));
}

TEST(EventIo, RejectsBubblesThatCannotExist) {
    const std::string collapse = "[[event]]\nkind = \"collapse\"\nframe = 9\nbubble = [3, 80]\n";
    EXPECT_EQ(failure("[foam]\nbubbles = 80\n" + collapse),
              "a.toml:6: key 'event[1].bubble' = [3, 80]: must be below 80, the sum of "
              "foam.bubbles and the bubbles that events create; "
              "there is no bubble 80");
    // Bubbles that an event creates have the next identities.
    const std::string nucleate =
        "[[event]]\nkind = \"nucleate\"\nframe = 2\nat = [0.5, 0.5]\narea = 0.1\n";
    EXPECT_EQ(events("[foam]\nbubbles = 80\n" + collapse + nucleate).size(), 2U);
}

TEST(EventIo, ErrorNamesLocationKeyValueAndLimits) {
    EXPECT_EQ(failure("[[event]]\nkind = \"explode\"\n"),
              "a.toml:2: key 'event[1].kind' = \"explode\": must be " + allowed_kinds());
    EXPECT_EQ(failure("[[event]]\nkind = \"colapse\"\n"),
              "a.toml:2: key 'event[1].kind' = \"colapse\": must be " + allowed_kinds() +
                  "; did you mean 'collapse'?");
    EXPECT_EQ(failure("[[event]]\nframe = 1\n"),
              "a.toml:2: key 'event[1].frame' = 1: must be an integer from 2 to 100000");
    EXPECT_EQ(failure("[[event]]\nframes = [9, 8]\n"),
              "a.toml:2: key 'event[1].frames' = [9, 8]: must be [first, last], each an integer "
              "from 2 to 100000, first not above last");
    EXPECT_EQ(
        failure("[[event]]\nat = [0.5, 1.5]\n"),
        "a.toml:2: key 'event[1].at' = [0.5, 1.5]: must be [x, y], each a number from 0 to 1");
    EXPECT_EQ(failure("[[event]]\nbubble = [3, -1]\n"),
              "a.toml:2: key 'event[1].bubble' = [3, -1]: must be an integer from 0 to 4294967294, "
              "or a list of such values");
    EXPECT_EQ(failure("[[event]]\nsides = []\n"),
              "a.toml:2: key 'event[1].sides' = []: must be an integer from 2 to 100, or a list of "
              "such values");
}

TEST(EventIo, AMisspelledTableSuggestsEvents) {
    EXPECT_EQ(failure("[[evnt]]\nsides = 6\n"),
              "a.toml:1: key 'evnt[1]' = {...}: unknown table; did you mean 'event'?");
}

TEST(EventIo, AnUnknownKeySuggestsTheNearest) {
    EXPECT_EQ(failure("[[event]]\n[[event]]\nfrmaes = [2, 3]\n"),
              "a.toml:3: key 'event[2].frmaes' = [2, 3]: unknown key; did you mean 'frames'?");
    EXPECT_EQ(failure("[[event]]\nwhatever = 2\n"),
              "a.toml:2: key 'event[1].whatever' = 2: unknown key; "
              "'foamtex presets keys' lists all keys");
}

TEST(EventIo, AnEventMustBeATableOfAList) {
    const std::string reason =
        "an event must be a table in an array of tables, which begins with [[event]]";
    EXPECT_EQ(failure("[event]\nkind = \"drive\"\n"), "a.toml:1: key 'event' = {...}: " + reason);
    EXPECT_EQ(failure("event = 3\n"), "a.toml:1: key 'event' = 3: " + reason);
    EXPECT_EQ(failure("event = []\n"), "a.toml:1: key 'event' = []: " + reason);
}

TEST(EventIo, AnEventNeedsAKindAndFrames) {
    EXPECT_EQ(failure("[foam]\n[[event]]\n"),
              "a.toml:2: key 'event[1]' = {...}: the event must have a kind, " + allowed_kinds());
    EXPECT_EQ(
        failure("[[event]]\nkind = \"drive\"\nscale = 2\n"),
        "a.toml:2: key 'event[1].kind' = \"drive\": exactly one of the keys frame, frames and "
        "time must be given");
    EXPECT_EQ(failure("[[event]]\nkind = \"drive\"\nframe = 3\nframes = [3, 4]\n"),
              "a.toml:4: key 'event[1].frames' = [3, 4]: exactly one of the keys frame, frames and "
              "time must be given");
}

TEST(EventIo, ATimeReplacesFrames) {
    const std::string toml = "[[event]]\nkind = \"shear\"\ntime = ";
    EXPECT_EQ(events(toml + "3.5\n")[0].time, (std::array{3.5, 3.5}));
    EXPECT_EQ(events(toml + "[3, 4.5]\n")[0].time, (std::array{3.0, 4.5}));
    EXPECT_EQ(failure(toml + "[4, 3]\n"),
              "a.toml:3: key 'event[1].time' = [4, 3]: must be a number from 0 to 1000000000000, "
              "or [from, to] with from not above to");
    EXPECT_EQ(
        failure(toml + "3\nframe = 4\n"),
        "a.toml:3: key 'event[1].time' = 3: exactly one of the keys frame, frames and time must "
        "be given");
    EXPECT_EQ(failure(toml + "1e9\n"),
              "a.toml:3: key 'event[1].time' = 1000000000.0: must be a time of frame 100000 or "
              "earlier; frames.time_step, frames.step_growth and frames.warm_up determine the "
              "times of frames");
}

// The last assignment takes effect, as for every other key.
TEST(EventIo, ALaterTimeOverridesFrames) {
    Preset preset = parse_preset("[[event]]\nkind = \"shear\"\nframes = [3, 4]\n", "a", "a.toml");
    assign(preset, std::vector{read_set_argument("event[1].time=[2, 8]")});
    EXPECT_EQ(preset.events[0].frames, FrameSpan{});
    const std::string back = events_to_toml(preset);
    EXPECT_EQ(events(back)[0].time, (std::array{2.0, 8.0}));
    assign(preset, std::vector{read_set_argument("event[1].frame=5")});
    EXPECT_FALSE(preset.events[0].time.has_value());
    EXPECT_EQ(preset.events[0].frames, (FrameSpan{5, 5}));
}

TEST(EventIo, BlamesTheAssignmentThatNoLongerFits) {
    EXPECT_EQ(failure("[[event]]\nkind = \"shear\"\nframe = 3\n",
                      {"foam.domain=patch", "output.pattern=b.png"}),
              "--set foam.domain=patch: key 'foam.domain' = \"patch\": event[1].kind = "
              "\"shear\" is only allowed with foam.domain = \"torus\"");
}

TEST(EventIo, AKeyOfAnotherKindIsRejected) {
    EXPECT_EQ(
        failure("[[event]]\narea = 0.5\nkind = \"collapse\"\nframe = 3\nbubble = 4\n"),
        "a.toml:2: key 'event[1].area' = 0.5: not a key of kind \"collapse\"; must be one of kind, "
        "frame, frames, time, bubble, at, sides, count, order");
    EXPECT_EQ(failure("[[event]]\nkind = \"nucleate\"\nframe = 3\nbubble = 4\n")
                  .find("a.toml:4: key 'event[1].bubble' = 4: not a key of kind \"nucleate\""),
              0U);
    EXPECT_EQ(failure("[[event]]\nkind = \"drive\"\nframe = 3\ngrowth = 4\n")
                  .find("a.toml:4: key 'event[1].growth' = 4: not a key of kind \"drive\""),
              0U);
}

TEST(EventIo, BubblesAreChosenInOneWay) {
    EXPECT_EQ(failure("[[event]]\nkind = \"collapse\"\nframe = 3\n"),
              "a.toml:2: key 'event[1].kind' = \"collapse\": the event must have one of the keys "
              "bubble, at and sides, which choose bubbles");
    EXPECT_EQ(failure("[[event]]\nkind = \"collapse\"\nframe = 3\nbubble = 4\nsides = 5\n"),
              "a.toml:5: key 'event[1].sides' = 5: only one of the keys bubble, at and sides may "
              "be given");
    EXPECT_EQ(
        failure("[[event]]\nkind = \"drive\"\nframe = 3\nat = [0, 0]\nbubble = 4\n"),
        "a.toml:4: key 'event[1].at' = [0, 0]: only one of the keys bubble, at and sides may be "
        "given");
    EXPECT_EQ(failure("[[event]]\nkind = \"collapse\"\nframe = 3\nbubble = 4\ncount = 5\n"),
              "a.toml:5: key 'event[1].count' = 5: only allowed together with the key sides");
    EXPECT_EQ(failure("[[event]]\nkind = \"drive\"\nframe = 3\n"), "no failure");  // all bubbles
}

TEST(EventIo, BubblesInTurnNeedAFrameEach) {
    const std::string event =
        "[[event]]\nkind = \"collapse\"\nsides = 5\ncount = 4\norder = \"in-turn\"\n";
    EXPECT_EQ(failure(event + "frames = [2, 5]\n"), "no failure");
    EXPECT_EQ(failure(event + "frames = [2, 4]\n"),
              "a.toml:5: key 'event[1].order' = \"in-turn\": "
              "4 bubbles that collapse in turn need at least as many frames; the event has 3");
}

TEST(EventIo, ANewBubbleIsLargerThanTheT2Area) {
    const std::string event = "[[event]]\nkind = \"nucleate\"\nframe = 9\narea = 0.02\n";
    EXPECT_EQ(failure(event), "no failure");
    EXPECT_EQ(failure("[dynamics]\nt2_area = 0.02\n" + event),
              "a.toml:6: key 'event[1].area' = 0.02: must be above dynamics.t2_area = 0.02");
    // Another key of the event, which is assigned at the same time, is not the cause.
    EXPECT_EQ(failure(event, {"dynamics.t2_area=0.03", "event[1].growth=3"}),
              "--set dynamics.t2_area=0.03: key 'dynamics.t2_area' = 0.03: event[1].area = 0.02 "
              "must be above dynamics.t2_area = 0.03");
}

TEST(EventIo, OnlyOneNewBubbleMayHaveAPosition) {
    EXPECT_EQ(
        failure("[[event]]\nkind = \"nucleate\"\nframe = 9\nat = [0, 0]\ncount = 2\n"),
        "a.toml:5: key 'event[1].count' = 2: must be 1 if the event has a position (the key 'at')");
}

// 64 bubbles in a square image are on a torus of 8 x 8 foam units.
TEST(EventIo, AForceHasAPositionAndFitsTheTorus) {
    const std::string event = "[foam]\nbubbles = 64\n[[event]]\nkind = \"force\"\nframe = 3\n";
    EXPECT_EQ(failure(event),
              "a.toml:4: key 'event[1].kind' = \"force\": the event must have the key 'at', the "
              "position of the push");
    EXPECT_EQ(failure(event + "at = [0, 0]\nradius = 4\n"), "no failure");
    EXPECT_EQ(failure(event + "at = [0, 0]\nradius = 4.1\n"),
              "a.toml:7: key 'event[1].radius' = 4.1: must be at most 4, half of the shorter side "
              "of the torus");
    EXPECT_EQ(failure(event + "at = [0, 0]\nradius = 4\n",
                      {"image.size=[100, 50]", "event[1].push=[1, 0]"}),
              "--set image.size=[100, 50]: key 'image.size' = [100, 50]: event[1].radius must be "
              "at most 2.83, half of the shorter side of the torus");
}

TEST(EventIo, SetChangesAnExistingEvent) {
    const std::string toml = "[[event]]\nkind = \"collapse\"\nframe = 3\nbubble = 4\n";
    Preset preset = parse_preset(toml, "a", "a.toml");
    assign(preset, std::vector{read_set_argument("event[1].frames=[7, 9]")});
    EXPECT_EQ(preset.events[0].frames, (FrameSpan{7, 9}));
    EXPECT_EQ(failure(toml, {"event[2].frame=4"}),
              "--set event[2].frame=4: key 'event[2].frame' = 4: the preset has no event 2; "
              "the number of its events is 1");
    EXPECT_EQ(failure(toml, {"event[1].kind=nucleate"})
                  .find("--set event[1].kind=nucleate: key 'event[1].kind' = \"nucleate\": "
                        "not a key of kind \"nucleate\""),
              0U);
    EXPECT_NE(failure(toml, {"event[x].frame=4"}), "no failure");
    EXPECT_NE(failure(toml, {"event[0].frame=4"}), "no failure");
}

TEST(EventIo, RoundTrips) {
    const std::string toml =
        "\n[[event]]\nkind = \"collapse\"\nframes = [5, 8]\nsides = [4, 5]\ncount = 3\n"
        "order = \"in-turn\"\n"
        "\n[[event]]\nkind = \"nucleate\"\nframe = 3\nat = [0.25, 1.0]\non = \"film\"\n"
        "area = 0.3\ngrowth = 4\n"
        "\n[[event]]\nkind = \"drive\"\nframes = [2, 49]\nbubble = [3, 4]\nscale = 2.0\n"
        "amplitude = 0.2\nperiod = 12.0\nphase = 0.5\nphases = \"random\"\n";
    const Preset preset = parse_preset(toml, "a", "a.toml");
    EXPECT_EQ(events_to_toml(preset), toml);
    const std::string whole = to_toml(preset);
    EXPECT_EQ(to_toml(parse_preset(whole, "a", "a.toml")), whole);
}

TEST(EventIo, TheReferenceHasMeaningAndLimitsOfEveryKey) {
    const std::string reference = describe_keys();
    for (const KeyInfo& key : event_keys()) {
        EXPECT_NE(reference.find(describe(key)), std::string::npos) << key.path;
    }
    EXPECT_NE(reference.find("\n[[event]]\nkind\n"), std::string::npos);
    EXPECT_NE(reference.find("\ncount = 1\n"), std::string::npos);
}

TEST(EventIo, APatchIsNotSheared) {
    const std::string shear = "[[event]]\nkind = \"shear\"\nframe = 5\n";
    EXPECT_EQ(failure("[foam]\ndomain = \"patch\"\n" + shear),
              "a.toml:4: key 'event[1].kind' = \"shear\": \"shear\" is only allowed with "
              "foam.domain = \"torus\"");
    EXPECT_EQ(failure(shear, {"foam.domain=patch"}),
              "--set foam.domain=patch: key 'foam.domain' = \"patch\": event[1].kind = \"shear\" "
              "is only allowed with foam.domain = \"torus\"");
}

TEST(EventIo, APushOfAPatchMayBeOfAnySize) {
    const std::string force =
        "[[event]]\nkind = \"force\"\nframe = 5\nat = [0.5, 0.5]\nradius = 100\n";
    EXPECT_NE(failure(force), "no failure");
    EXPECT_EQ(failure("[foam]\ndomain = \"patch\"\n" + force), "no failure");
}

}  // namespace
}  // namespace foam::texgen
