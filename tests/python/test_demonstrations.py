# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Demonstrations are read back by lerobot and by pyarrow, and replay to the same reward."""

import json
import shutil
import subprocess
import sys

import numpy as np
import pytest

from graspless import TaskError, _data

pytest.importorskip("gymnasium", reason="gymnasium is not installed (extra gym)")
pytest.importorskip("pyarrow", reason="pyarrow is not installed (extra gym)")

import pyarrow.parquet as pq

from graspless.environments import PlanEnv, demonstrate, demonstrations


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """The folder of two episodes of Pick, and each episode by its seed."""
    path = tmp_path_factory.mktemp("demonstrations") / "pick"
    told, episodes, true = [], {}, demonstrations._Takes._record

    def record(self, seed, film):
        episodes[seed] = true(self, seed, film)
        return episodes[seed]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(demonstrations._Takes, "_record", record)
        tried = demonstrate("Pick", path, 2, seed=2, progress=lambda *n: told.append(n))
    assert told[-1] == (2, tried)
    assert list(episodes) == [2, 3]
    return path, episodes


@pytest.fixture
def folder(recorded):
    """Two episodes of Pick."""
    return recorded[0]


def columns(folder):
    table = pq.read_table(folder / "data/chunk-000/file-000.parquet")
    return {name: np.array(table[name].to_pylist()) for name in table.column_names}


def test_actions_replay_to_the_same_states_and_reward(folder):
    found, env = columns(folder), PlanEnv("Pick")
    own = found["episode_index"] == 0
    observation, _ = env.reset(seed=2)
    for state, action, reward in zip(
        found["observation.state"][own],
        found["action"][own],
        found["next.reward"][own],
        strict=True,
    ):
        np.testing.assert_array_equal(observation, state.astype(np.float32))
        observation, rewarded, ended, _, _ = env.step(action)
        assert rewarded == reward
    assert ended
    assert rewarded == 1


def test_frames_are_numbered_as_the_episodes_say(folder):
    found = columns(folder)
    info = json.loads((folder / "meta/info.json").read_text())
    rows = pq.read_table(folder / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    assert info["total_episodes"] == len(rows) == 2
    assert info["total_frames"] == len(found["index"]) == sum(row["length"] for row in rows)
    for row in rows:
        part = slice(row["dataset_from_index"], row["dataset_to_index"])
        assert set(found["episode_index"][part]) == {row["episode_index"]}
        np.testing.assert_array_equal(found["frame_index"][part], np.arange(row["length"]))
        np.testing.assert_allclose(found["timestamp"][part], np.arange(row["length"]) / 50)
        lowest = found["action"][part].min(axis=0)
        np.testing.assert_allclose(row["stats/action/min"], lowest, rtol=1e-6)
    for name, feature in info["features"].items():
        assert list(found[name].shape[1:]) == (feature["shape"] if feature["names"] else [])


def test_lerobot_reads_them(folder):
    pytest.importorskip("lerobot", reason="lerobot is not installed")
    from lerobot.datasets.lerobot_dataset import LeRobotDataset

    dataset, found = LeRobotDataset("graspless/pick", root=folder), columns(folder)
    assert (dataset.num_episodes, dataset.num_frames) == (2, len(found["index"]))
    for i in (0, 1, len(dataset) - 1):
        frame = dataset[i]
        assert frame["task"] == "pick up the object"
        for name in ("observation.state", "action"):
            np.testing.assert_array_equal(frame[name].numpy(), found[name][i].astype(np.float32))


def recorder(monkeypatch, holds, known):
    """Records episodes that hold by their seeds, but those that are known; returns the seeds that
    were asked for.
    """
    seeds, true = [], demonstrations._Takes._record

    def record(self, seed, film):
        seeds.append(seed)
        if not holds(seed):
            return None
        return known[seed] if seed in known else true(self, seed, film)

    monkeypatch.setattr(demonstrations._Takes, "_record", record)
    return seeds


def test_only_what_held_is_kept(tmp_path, monkeypatch, recorded):
    seeds = recorder(monkeypatch, lambda seed: seed % 2, recorded[1])
    assert demonstrate("Pick", tmp_path / "a", 1, seed=2) == 2
    assert seeds == [2, 3]
    recorder(monkeypatch, lambda _: False, {})
    with pytest.raises(TaskError, match="Pick: 20 episodes in a row did not hold"):
        demonstrate("Pick", tmp_path / "b", 1)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b.part"]


def test_an_interrupted_recording_goes_on(tmp_path, monkeypatch, recorded):
    folder, episodes = recorded
    seeds = recorder(monkeypatch, lambda _: True, {2: episodes[2]})

    (tmp_path / "a.part").mkdir()  # of a run that was interrupted at once

    def interrupt(held, tried):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        demonstrate("Pick", tmp_path / "a", 2, seed=2, progress=interrupt)
    with pytest.raises(TaskError, match=r"a.part: has episodes of other settings, .*'Pick'"):
        demonstrate("Tumble", tmp_path / "a", 2)
    assert demonstrate("Pick", tmp_path / "a", 2, seed=2) == 2
    assert seeds == [2, 3]  # the first was not recorded again
    for cut in (0, 1000):  # as a crash of the machine leaves it
        shutil.rmtree(tmp_path / "a")
        with pytest.raises(KeyboardInterrupt):
            demonstrate("Pick", tmp_path / "a", 2, seed=2, progress=interrupt)
        part = tmp_path / "a.part" / "2.npz"
        part.write_bytes(part.read_bytes()[:cut])
        seeds.clear()
        assert demonstrate("Pick", tmp_path / "a", 2, seed=2) == 2
        assert seeds == [2, 3]
    assert [path.name for path in tmp_path.iterdir()] == ["a"]
    for name, values in columns(tmp_path / "a").items():
        np.testing.assert_array_equal(values, columns(folder)[name])


def run(*arguments):
    command = [sys.executable, "-m", "graspless", "demonstrate", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_the_command_writes_the_same(tmp_path, folder):
    done = run("Pick", "-o", str(tmp_path / "a"), "--episodes", "2", "--seed", "2")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("2 of 2 episodes held: ")
    for name, values in columns(tmp_path / "a").items():
        np.testing.assert_array_equal(values, columns(folder)[name])
    again = run("Pick", "-o", str(tmp_path / "a"))
    assert again.returncode == 2
    assert "a: is a complete recording: should be a new folder" in again.stderr


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    """Two episodes with videos."""
    pytest.importorskip("av", reason="PyAV is not installed (extra video)")
    path = tmp_path_factory.mktemp("film") / "pick"
    done = run("Pick", "-o", str(path), "--episodes", "2", "--seed", "2", "--video")
    if "cannot render here" in done.stderr:
        pytest.skip("MuJoCo cannot render here")
    assert done.returncode == 0, done.stderr
    return path


def test_videos_show_every_frame(film):
    import av

    found, stats = columns(film), json.loads((film / "meta/stats.json").read_text())
    for k in range(2):
        path = film / f"videos/observation.images.front/chunk-000/file-{k:03}.mp4"
        with av.open(str(path)) as container:
            pictures = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
        assert len(pictures) == (found["episode_index"] == k).sum()
        assert pictures[0].shape == (192, 256, 3)
        moved = np.abs(pictures[0].astype(int) - pictures[-1]).max(axis=2) > 50
        assert 0.001 < moved.mean() < 0.5  # the arm, not the whole picture
    of_all = np.array(stats["observation.images.front"]["mean"]).ravel()
    assert (np.abs(of_all - np.array(pictures).mean(axis=(0, 1, 2)) / 255) < 0.05).all()


@pytest.mark.filterwarnings("ignore:The video decoding:UserWarning")  # of torchvision
def test_lerobot_reads_videos(film):
    pytest.importorskip("lerobot", reason="lerobot is not installed")
    from lerobot.datasets.lerobot_dataset import LeRobotDataset

    dataset = LeRobotDataset("graspless/pick", root=film, video_backend="pyav")
    assert dataset[len(dataset) - 1]["observation.images.front"].shape == (3, 192, 256)


def test_bad_input_is_told(tmp_path):
    with pytest.raises(TaskError, match="name: Throw: should be one of"):
        demonstrate("Throw", tmp_path / "a", 1)
    with pytest.raises((TaskError, ValueError), match="episodes"):
        demonstrate("Pick", tmp_path / "a", 0)
    with pytest.raises(TaskError, match="cannot be written"):
        demonstrate("Pick", tmp_path, 1)
    assert not list(tmp_path.iterdir())


def test_without_its_extra_no_film_is_begun(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(TaskError, match="needs av: "):
        demonstrate("Pick", tmp_path / "a", 1, images=True)
    assert not list(tmp_path.iterdir())


def test_the_example_learns_from_demonstrations(tmp_path):
    script = _data.directory("examples") / "clone_planner.py"

    def run(*arguments):
        command = [sys.executable, str(script), *arguments]
        return subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)

    demonstrate("Tumble", tmp_path / "tumbles", 4, seed=1)
    done = run("tumbles", "1")
    assert (done.returncode, done.stderr) == (0, "")
    assert "of 1 new tasks" in done.stdout
    assert done.stdout.endswith("the planner 1\n")
    helped = run()
    assert helped.returncode == 1
    assert "clone_planner.py tumbles 50" in helped.stderr
