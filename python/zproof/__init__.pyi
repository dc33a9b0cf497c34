from zproof import filters as filters
from zproof._zproof import BACKGROUND_ID as BACKGROUND_ID
from zproof._zproof import CLASS_COLOURS as CLASS_COLOURS
from zproof._zproof import CLASS_NAMES as CLASS_NAMES
from zproof._zproof import Diagnosis as Diagnosis
from zproof._zproof import Explanation as Explanation
from zproof._zproof import Finding as Finding
from zproof._zproof import Frame as Frame
from zproof._zproof import InputError as InputError
from zproof._zproof import NearTriangle as NearTriangle
from zproof._zproof import Scene as Scene
from zproof._zproof import Verdict as Verdict
from zproof._zproof import View as View
from zproof._zproof import load as load
from zproof._zproof import render as render
from zproof._zproof import trace as trace
from zproof.judging import assert_proven as assert_proven
from zproof.judging import judge as judge
from zproof.judging import save_all as save_all
from zproof.judging import story_of_worst as story_of_worst
from zproof.judging import summary as summary

__all__: list[str]
__version__: str
