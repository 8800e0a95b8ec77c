import sys, time
sys.path.insert(0,'/work/draw/tests/blender')
import bpy, numpy as np
from addon_under_test import part, sample
from networks import *
def test_x():
    hull=sample(sys.argv[-1] if sys.argv[-1] in ("coaster","bulk_carrier","container_ship") else "container_ship")
    pts=np.array([v.co for v in hull.data.vertices]); lo,hi=pts.min(0),pts.max(0)
    st=" ".join(f"{x:.3f}" for x in np.linspace(lo[0],hi[0],21)[1:-1])
    wl=" ".join(f"{x:.3f}" for x in np.linspace(lo[2],hi[2],11)[1:-1])
    t=time.time()
    assert bpy.ops.hull.network_from_hull(stations=st,waterlines=wl)=={"FINISHED"}
    print("from hull",time.time()-t)
    net=part("bridge.objects.networks").all_networks()[-1]
    s=state_of(net)
    print(len(s.curves), s.network.region_count, sorted((len(c.points)) for c in s.curves.values()))
    for p in s.problems[:4]: print("  ", p.is_note, p.text)
    net.hull_network.show_surface=True
    bpy.context.view_layer.update()
    t=time.time(); finish(); print("finish",time.time()-t, len(surface_points(net)))
    if not s.network.region_count:
        for nm in s.curves:
            if nm.startswith("Station 49.328"):
                np.set_printoptions(precision=3,suppress=True,linewidth=150)
                print(nm, s.curves[nm].points, s.curves[nm].knuckles)
        nn=np.asarray(s.network.nodes); from collections import defaultdict
        dd=defaultdict(set)
        for (a,b),c in zip(s.network.edges,s.network.edge_curves):
            dd[a].add(s.joined[c]); dd[b].add(s.joined[c])
        for i,pt in enumerate(nn):
            if abs(pt[0]-49.328)<0.01: print(i,pt,dd[i])
    # distance from hull
    native=part("bridge.native").require()
    surface=part("features.hull.hull_state").state_of(hull).ship.surface
    d=np.asarray(native.SurfaceTree(surface).closest_points(surface_points(net).astype(float)).distances)
    L=np.ptp(pts[:,0]); print("rms/L",np.sqrt(np.mean(d**2))/L,"max/L",d.max()/L)
    import cProfile,pstats
    obj=next(o for o in net.objects if o.name.startswith("Station 1") and o.type=="CURVE")
    n=len(obj.data.splines[0].bezier_points)
    times=[]
    pr=cProfile.Profile()
    for k in range(12):
        i=n//2
        t=time.time()
        if k==6: pr.enable()
        before=dict(state_of(net).curves)
        move_point(obj,i,(0,0.02,0.01))
        if k<2:
            now=state_of(net).curves
            for nm in now:
                if now[nm].pieces is not before[nm].pieces: print("   changed",nm, np.abs(now[nm].points-before[nm].points).max(), [(i,str(a)[:80],str(b)[:80]) for i,(a,b) in enumerate(zip(now[nm].key,before[nm].key)) if a!=b])
        times.append(time.time()-t)
    pr.disable()
    print("move", [round(1e3*t) for t in times])
    pstats.Stats(pr).sort_stats("cumtime").print_stats(28)
    print("problems",[p.text for p in state_of(net).problems if not p.is_note][:3])
